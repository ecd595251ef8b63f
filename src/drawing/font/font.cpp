#include "drawing/font/font.hpp"
