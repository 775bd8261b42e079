#pragma once
/// The TOML library, as all files here see it: errors as values, and numbers that are read without the memory and the locale
/// that streams take.

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_FLOAT_CHARCONV 1
#include <toml++/toml.h>
