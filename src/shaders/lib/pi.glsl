#ifndef OPALINE_LIB_PI
#define OPALINE_LIB_PI

const float pi = 3.14159265358979;

#endif
