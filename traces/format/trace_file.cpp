#include "traces/format/trace_file.h"
