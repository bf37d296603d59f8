/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stateDictionary.H"

#include "allDigits.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::stateDictionary::stateDictionary
(
    const word& name,
    const objectRegistry& registry,
    const wordList& entries,
    const IOobject::writeOption write
)
:
    IOdictionary
    (
        IOobject
        (
            name,
            registry.time().timeName(),
            "uniform",
            registry,
            IOobject::READ_IF_PRESENT,
            write
        )
    )
{
    // A file whose header is cut off is passed over by READ_IF_PRESENT
    if (returnReduce(!filePath().empty(), orOp<bool>()))
    {
        require(*this, entries);
    }
}


Foam::stateDictionary::stateDictionary
(
    const IOobject& io,
    const dictionary& entries
)
:
    IOdictionary(io, entries)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::stateDictionary::require
(
    const dictionary& state,
    const wordList& entries
)
{
    for (const word& key : entries)
    {
        if (!state.found(key))
        {
            FatalIOErrorInFunction(state)
                << "The file " << state.name() << ", from which the run is to"
                << " go on, is not whole: it has no entry '" << key << "'."
                << " Go on from an earlier time"
                << exit(FatalIOError);
        }
    }
}


bool Foam::stateDictionary::writeData(Ostream& os) const
{
    const int digits = os.precision(allDigits::number);
    const bool ok = IOdictionary::writeData(os);
    os.precision(digits);

    return ok;
}


// ************************************************************************* //
