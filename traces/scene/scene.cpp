#include "traces/scene/scene.h"
