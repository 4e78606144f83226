#include "model/unit/config.h"
