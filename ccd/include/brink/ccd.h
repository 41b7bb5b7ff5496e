// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/distance.h>
#include <brink/motion.h>
#include <brink/overlap.h>
#include <brink/ray.h>
#include <brink/scene.h>
#include <brink/shape.h>
#include <brink/toi.h>
