// The only place that compiles tinygltf; everyone else includes scene/gltf/file.h. Its shared
// library is not used, since Draco's may export another version of the same functions.

#include <fstream>  // for the library's writer, which cannot be left out

#define TINYGLTF_IMPLEMENTATION
#include "scene/gltf/file.h"
