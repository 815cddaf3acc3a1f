#include "app/render/picture_job.hpp"

#include "app/render/picture_files.hpp"
#include "base/version.hpp"
#include "picture/option_table.hpp"
#include "rendering/adaptive.hpp"
#include "rendering/uniform_render.hpp"

namespace penumbra {

PictureJob picture_job(const RenderOptions& options, const SceneFile& file, const Picture& picture, int number) {
  PictureJob job;
  job.scene = with_options(*picture.scene, options);
  const Settings& settings = job.scene.settings;
  job.plan.crop = options.crop.value_or(PixelRect{0, 0, settings.width, settings.height});
  job.plan.layers = options.layers;
  job.plan.threads = threads_of(options.machine);
  job.plan.shard = options.session.shard.value_or(Shard{});
  job.development = {settings.width,
                     settings.height,
                     picture.rects,
                     metadata_for(options.scene, job.scene, options),
                     options.exposure_halves,
                     options.bits,
                     settings.course != Course::off ? Rounding::course : Rounding::nearest};
  job.key = {version, file.hash, number, plan_in_words(job.scene, options)};
  if (options.frame) job.development.metadata.emplace_back(content_entry, content_key(job.key, job.development));
  return job;
}

NoiseGoal goal_of(const RenderOptions& options, const Settings& settings) {
  return {static_cast<float>(*options.noise), static_cast<std::uint32_t>(settings.rays_per_pixel),
          static_cast<std::uint32_t>(options.first_rays.value_or(0))};
}

std::unique_ptr<ResumableRender> render_of(const PictureJob& job, const RenderOptions& options, const Frame& frame,
                                           const Kernel& kernel) {
  const auto rays = static_cast<std::uint32_t>(frame.settings.rays_per_pixel);
  if (options.noise) {
    return std::make_unique<AdaptiveRender>(frame, kernel, job.plan, goal_of(options, frame.settings));
  }
  const bool in_passes = options.session.can_be_interrupted() && !options.session.shard;
  return std::make_unique<UniformRender>(frame, kernel, job.plan, rays, in_passes);
}

}  // namespace penumbra
