// The only place that compiles stb_image and stb_image_write; everyone else includes the headers.
// Files are read by our own code, which checks their length first, so no function that opens files.

#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#include <stb_image.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>
