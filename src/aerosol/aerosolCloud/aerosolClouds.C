/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aerosolClouds.H"
#include "fvMesh.H"
#include "propertiesFile.H"
#include "runGuard.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::aerosol::aerosolClouds::each
(
    std::string (aerosolCloud::*what)() const,
    const char* between
) const
{
    std::string all;

    for (const aerosolCloud& cloud : clouds_)
    {
        all +=
            (all.empty() ? "" : between)
          + (clouds_.size() > 1 ? cloud.name() + ": " : std::string())
          + (cloud.*what)();
    }

    return all;
}


void Foam::aerosol::aerosolClouds::makeClouds
(
    const fvMesh& mesh,
    acoustics::soundField& sound
)
{
    if (!hasProperties("aerosolProperties", mesh))
    {
        Info<< "No constant/aerosolProperties: sound without particles" << nl
            << endl;
        return;
    }

    const IOdictionary common(readProperties("aerosolProperties", mesh));

    const runGuard::activity what
    (
        "making the aerosol of constant/aerosolProperties"
    );

    if (!common.found("clouds"))
    {
        clouds_.append(new aerosolCloud("aerosol", common, mesh, sound));
        return;
    }

    for (const entry& e : common.subDict("clouds"))
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(common.subDict("clouds"))
                << "Entry '" << e.keyword() << "' is no dictionary: each cloud"
                << " is one, of the name of the cloud and with what is"
                << " different there"
                << exit(FatalIOError);
        }

        Info<< nl << "Cloud " << e.keyword() << nl;

        dictionary dict(common);
        dict.remove("clouds");
        replace(dict, e.dict());

        clouds_.append(new aerosolCloud(e.keyword(), dict, mesh, sound));
    }

    if (clouds_.empty())
    {
        FatalIOErrorInFunction(common.subDict("clouds"))
            << "There are no clouds in 'clouds': name one or more, or remove"
            << " the dictionary to have one of the name aerosol"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::aerosolClouds::aerosolClouds
(
    const fvMesh& mesh,
    acoustics::soundField& sound
)
{
    makeClouds(mesh, sound);

    for (aerosolCloud& cloud : clouds_)
    {
        if (cloud.coupled())
        {
            if (!reaction_)
            {
                reaction_.reset(new gasReaction(mesh, sound));
            }

            cloud.couple(*reaction_);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::aerosolClouds::replace
(
    dictionary& common,
    const dictionary& own
)
{
    for (const entry& e : own)
    {
        // Entries of one type are none of another
        const bool whole =
            !e.isDict() || e.dict().found("type") || e.dict().found("source");

        if (!whole && common.isDict(e.keyword()))
        {
            replace(common.subDict(e.keyword()), e.dict());
        }
        else
        {
            common.set(e.clone(common).ptr());
        }
    }
}


void Foam::aerosol::aerosolClouds::begin()
{
    for (aerosolCloud& cloud : clouds_)
    {
        cloud.begin();
    }
}


void Foam::aerosol::aerosolClouds::evolve()
{
    if (reaction_)
    {
        reaction_->begin();
    }

    for (aerosolCloud& cloud : clouds_)
    {
        cloud.evolve();
    }

    if (reaction_)
    {
        reaction_->end();
    }
}


void Foam::aerosol::aerosolClouds::end()
{
    for (aerosolCloud& cloud : clouds_)
    {
        cloud.end();
    }
}


std::string Foam::aerosol::aerosolClouds::progress() const
{
    return each(&aerosolCloud::progress, "\n    ");
}


std::string Foam::aerosol::aerosolClouds::effort() const
{
    return each(&aerosolCloud::effort, "\n");
}


// ************************************************************************* //
