#include "traces/raster/capture.h"
