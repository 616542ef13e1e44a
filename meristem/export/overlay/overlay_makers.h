// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "meristem/export/overlay/overlay.h"

namespace meristem {

/// The input of all functions that fill a layer.
struct OverlaySubject {
  const Plant& plant;  ///< without plantings if a part reads the plant
  const Scene& scene;
  const StepMarks& marks;
  Box bounds;  ///< box around the plant and its attraction points
  Vec3 right{1, 0, 0};
  const Progress& progress;
};

/// Returns true if a stem is a self-organizing tree, whose metamers record the light of their buds.
bool has_buds(const Skeleton& skeleton);

// Each function fills a layer with one part.

void show_points(const OverlaySubject& subject, OverlayLayer& layer);
void show_pulls(const OverlaySubject& subject, OverlayLayer& layer);
void show_ways(const OverlaySubject& subject, OverlayLayer& layer);
void show_markers(const OverlaySubject& subject, OverlayLayer& layer);
void show_losses(const OverlaySubject& subject, OverlayLayer& layer);

void show_skeleton(const OverlaySubject& subject, OverlayLayer& layer);
void show_light(const OverlaySubject& subject, OverlayLayer& layer);
void show_resource(const OverlaySubject& subject, OverlayLayer& layer);
void show_hull(const OverlaySubject& subject, OverlayLayer& layer);
void show_supports(const OverlaySubject& subject, OverlayLayer& layer);
void show_box(const OverlaySubject& subject, OverlayLayer& layer);

void show_sun(const OverlaySubject& subject, OverlayLayer& layer);
void show_compass(const OverlaySubject& subject, OverlayLayer& layer);
void show_scale(const OverlaySubject& subject, OverlayLayer& layer);
void show_axes(const OverlaySubject& subject, OverlayLayer& layer);

}  // namespace meristem
