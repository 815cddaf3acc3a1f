// One picture of a scene file, ready to be rendered, and the key that identifies it.
#pragma once

#include <memory>

#include "app/options/render_options.hpp"
#include "language/scene_file.hpp"
#include "picture/develop.hpp"
#include "rendering/adaptive_rules.hpp"
#include "rendering/picture_key.hpp"
#include "rendering/resumable_render.hpp"

namespace penumbra {

struct PictureJob {
  Scene scene;  // with the options applied
  Plan plan;
  Development development;
  PictureKey key;
};

// Picture `number` of the file, counted from 1, with the options of the current frame.
PictureJob picture_job(const RenderOptions& options, const SceneFile& file, const Picture& picture, int number);

// What --noise asks for, which must be given.
NoiseGoal goal_of(const RenderOptions& options, const Settings& settings);

// The render of a job whose scene was compiled into `frame`. Frame and kernel must outlive it.
std::unique_ptr<ResumableRender> render_of(const PictureJob& job, const RenderOptions& options, const Frame& frame,
                                           const Kernel& kernel);

}  // namespace penumbra
