#pragma once

namespace morph {

/// Keep OpenBLAS from starting threads of its own: ours are busy, and its sums would depend on their number.
void keep_blas_serial();

} // namespace morph
