#pragma once

#include "libmorph/core/error.h"

#include <string>

namespace morph::test {

/// The message of the InputError that @p work throws; "nothing was thrown" if it does not.
template <typename Work>
std::string message_of(const Work& work)
{
    try {
        work();
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

} // namespace morph::test
