// Typesets the equations of a page by KaTeX, which is beside this file: without
// the network, and a fiftieth the size of MathJax, whose name and delimiters
// Sphinx and Doxygen know.

(function ()
{
    const here = document.currentScript.src.replace(/[^/]*$/, "");

    function load(name)
    {
        return new Promise(function (done, failed)
        {
            const script = document.createElement("script");
            script.src = here + "katex/" + name;
            script.onload = done;
            script.onerror = failed;
            document.head.appendChild(script);
        });
    }

    function render()
    {
        renderMathInElement
        (
            document.body,
            {
                delimiters:
                [
                    {left: "\\[", right: "\\]", display: true},
                    {left: "\\(", right: "\\)", display: false}
                ],
                throwOnError: false
            }
        );
    }

    const style = document.createElement("link");
    style.rel = "stylesheet";
    style.href = here + "katex/katex.min.css";
    document.head.appendChild(style);

    const parsed = new Promise(function (done)
    {
        if (document.readyState !== "loading") { done(); }
        else { document.addEventListener("DOMContentLoaded", done); }
    });

    load("katex.min.js")
        .then(function () { return load("contrib/auto-render.js"); })
        .then(function () { return parsed; })
        .then(render);
})();
