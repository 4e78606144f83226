#include "model/reference/reference.h"
