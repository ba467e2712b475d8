#pragma once
// The language of all headers: C++20. An #error would be the first of a screenful, for the compiler reads on
// to what an older C++ does not know; where a file is missing it stops.

#if __cplusplus < 202002L
#include <Gradus needs C++20: compile with -std=c++20 or later>
#endif
