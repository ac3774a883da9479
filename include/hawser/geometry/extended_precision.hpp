// Extended-precision floating type for triangles of nearly zero height, where double is not sufficient.
#pragma once

namespace hawser::detail {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Extended;  // 113 bits on x86-64
#else
using Extended = long double;
#endif

}  // namespace hawser::detail
