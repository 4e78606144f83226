#include "model/rivals/plain_map.h"
