#include "libmorph/numerics/serial_blas.h"

#include <cblas.h>

namespace morph {

void keep_blas_serial()
{
    static const bool done = (openblas_set_num_threads(1), true);
    static_cast<void>(done);
}

} // namespace morph
