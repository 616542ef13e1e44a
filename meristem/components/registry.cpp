// SPDX-License-Identifier: Apache-2.0
#include "meristem/components/registry.h"

#include "meristem/components/camera.h"
#include "meristem/components/cloud.h"
#include "meristem/components/colonize.h"
#include "meristem/components/ffd.h"
#include "meristem/components/field.h"
#include "meristem/components/grassleaf.h"
#include "meristem/components/horn.h"
#include "meristem/components/hydra.h"
#include "meristem/components/hyperpatch.h"
#include "meristem/components/leaf.h"
#include "meristem/components/lsystem.h"
#include "meristem/components/needles.h"
#include "meristem/components/organize.h"
#include "meristem/components/phiball.h"
#include "meristem/components/places.h"
#include "meristem/components/revolution.h"
#include "meristem/components/sequence.h"
#include "meristem/components/simple.h"
#include "meristem/components/skeleton.h"
#include "meristem/components/subdocument.h"
#include "meristem/components/tree.h"
#include "meristem/components/trim.h"
#include "meristem/components/world.h"
#include "meristem/components/wreath.h"

namespace meristem {

const Registry& builtin_components() {
  static const Registry registry({
      camera_component(),     simple_component(), revolution_component(), leaf_component(),        needles_component(),
      grassleaf_component(),  tree_component(),   horn_component(),       hydra_component(),       wreath_component(),
      phiball_component(),    field_component(),  places_component(),     subdocument_component(), colonize_component(),
      organize_component(),   cloud_component(),  lsystem_component(),    skeleton_component(),    ffd_component(),
      hyperpatch_component(), trim_component(),   world_component(),      sequence_component(),
  });
  return registry;
}

}  // namespace meristem
