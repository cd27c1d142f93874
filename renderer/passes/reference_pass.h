// Lights the G-buffer by Monte Carlo: the truth that the lighting pass approximates, from the same GLSL of the models. All light
// arrives: no surface stands in the way of another.
#pragma once

#include "renderer/environment_lighting.h"
#include "renderer/environment_sampler.h"
#include "renderer/passes/background_pass.h"
#include "renderer/passes/frame.h"
#include "renderer/passes/lighting_pass.h"

namespace glint {

class ReferencePass {
 public:
  ReferencePass(ProgramCache& programs, EnvironmentLighting& lighting, BackgroundPass& background)
      : programs_(programs), lighting_(lighting), background_(background) {}

  void setProgress(Progress progress) { progress_ = std::move(progress); }
  void forgetUnused() { environments_.nextFrame(1); }

  // Adds the mean of the samples `first` to `first + count` - 1 of each pixel, into a target of Output::Radiance: by many
  // draws, each of a bounded number of samples.
  void draw(Frame&, LightLists&, int first, int count);

 private:
  Diagnostics drawGroup(Frame&, LightLists&, const ReadyView&, size_t group, int first, int count);

  ProgramCache& programs_;
  EnvironmentLighting& lighting_;
  BackgroundPass& background_;
  RecentlyUsed<EnvironmentSampler> environments_;
  Progress progress_;
  double done_ = 0, all_ = 1;   // groups of the frame
};

}  // namespace glint
