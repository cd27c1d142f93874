// The parts of the renderer that need no OpenGL: clusters, light lists, lobes, harmonics.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/environment_lighting.h"
#include "renderer/light_tiles.h"
#include "renderer/lobe.h"
#include "renderer/mesh_clusters.h"
#include "tests/support/simple_scene.h"

namespace glint {
namespace {

TEST(MeshClusters, KeepEveryTriangleOnceWithItsWinding) {
  const MeshPtr mesh = sphereMesh(40, 20);
  const ClusteredMesh clustered = clusterMesh(*mesh, 32);
  const auto triangles = [](const std::vector<uint32_t>& indices) {
    std::vector<std::array<uint32_t, 3>> list;
    for (size_t i = 0; i + 2 < indices.size(); i += 3) list.push_back({indices[i], indices[i + 1], indices[i + 2]});
    std::sort(list.begin(), list.end());
    return list;
  };
  EXPECT_EQ(triangles(clustered.indices), triangles(mesh->indices));
  for (const Cluster& cluster : clustered.clusters) {
    EXPECT_LE(cluster.indexCount, 96u);
    for (uint32_t i = cluster.firstIndex; i < cluster.firstIndex + cluster.indexCount; ++i) {
      const Vertex& v = mesh->vertices[clustered.indices[i]];
      EXPECT_LE(glm::length(v.position - cluster.center), cluster.radius * 1.0001f);
      EXPECT_GE(glm::dot(v.normal, cluster.axis), cluster.coneCosine);
    }
  }
}

// No triangle that an eye sees may be in a cluster that is skipped, from anywhere.
TEST(MeshClusters, NoVisibleTriangleIsSkipped) {
  const MeshPtr mesh = shapeMesh("shaderball");
  const ClusteredMesh clustered = clusterMesh(*mesh);
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  size_t skipped = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const glm::vec3 direction = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
    const glm::vec3 eye = direction * (1.2f + 3.0f * static_cast<float>(trial % 5));
    for (const Cluster& cluster : clustered.clusters) {
      const bool away = facesAway(cluster.center, cluster.radius, cluster.axis, cluster.coneCosine, eye);
      const bool awayFrom = facesAwayFrom(cluster.axis, cluster.coneCosine, direction);
      skipped += away;
      for (uint32_t i = cluster.firstIndex; i < cluster.firstIndex + cluster.indexCount; i += 3) {
        const glm::vec3 a = mesh->vertices[clustered.indices[i]].position;
        const glm::vec3 b = mesh->vertices[clustered.indices[i + 1]].position;
        const glm::vec3 c = mesh->vertices[clustered.indices[i + 2]].position;
        const glm::vec3 n = glm::cross(b - a, c - a);
        if (away) {
          ASSERT_LE(glm::dot(n, eye - a), 1e-6f);
        }
        if (awayFrom) {
          ASSERT_LE(glm::dot(n, direction), 1e-6f);
        }
      }
    }
  }
  EXPECT_GT(skipped, clustered.clusters.size() * 60 / 5);
}

// Every light that reaches a point of a cluster above its surface is in the list of every tile the cluster covers.
TEST(LightTiles, ListEveryLightThatReachesASurface) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Light> lights;
  for (int i = 0; i < 300; ++i)
    lights.push_back({.kind = LightKind::Point, .position = {unit(random) * 8 - 4, unit(random) * 8 - 4, unit(random) * 3}, .radius = 0.3f + unit(random)});
  std::vector<VisibleCluster> clusters;
  for (int i = 0; i < 40; ++i) {
    VisibleCluster c;
    c.center = {unit(random) * 8 - 4, unit(random) * 8 - 4, unit(random)};
    c.radius = 0.3f;
    c.axis = glm::normalize(glm::vec3(unit(random) - 0.5f, unit(random) - 0.5f, 1));
    c.coneCosine = i % 3 == 0 ? -1.0f : 0.8f;
    const int x = static_cast<int>(unit(random) * 240), y = static_cast<int>(unit(random) * 160);
    c.pixels = {10 + x, 20 + y, 10 + x + 30, 20 + y + 25};
    clusters.push_back(c);
  }
  const glm::ivec4 rectangle{10, 20, 300, 200};
  const LightTiles tiles = buildLightTiles(clusters, lights, rectangle);
  size_t wanted = 0;
  for (const VisibleCluster& c : clusters)
    for (size_t l = 0; l < lights.size(); ++l) {
      // Some point and normal of the cluster that the light reaches from above.
      bool reaches = false;
      for (int s = 0; s < 40 && !reaches; ++s) {
        glm::vec3 p(unit(random) - 0.5f, unit(random) - 0.5f, unit(random) - 0.5f);
        p = c.center + glm::normalize(p) * c.radius * unit(random);
        const glm::vec3 toLight = lights[l].position - p;
        glm::vec3 n = glm::normalize(c.axis + 0.4f * glm::vec3(unit(random) - 0.5f, unit(random) - 0.5f, unit(random) - 0.5f));
        if (glm::dot(n, c.axis) < c.coneCosine) n = c.axis;
        reaches = glm::length(toLight) < lights[l].radius && (c.coneCosine < 0 || glm::dot(toLight, n) > 0);
      }
      if (!reaches) continue;
      ++wanted;
      for (const Tile& tile : tiles.tiles) {
        if (tile.x0 >= c.pixels.z || tile.x1 <= c.pixels.x || tile.y0 >= c.pixels.w || tile.y1 <= c.pixels.y) continue;
        const auto first = tiles.list.begin() + tile.first / kPointTexels;
        ASSERT_TRUE(std::find(first, first + tile.points, static_cast<uint32_t>(l)) != first + tile.points) << l;
      }
    }
  EXPECT_GT(wanted, 50u);
}

TEST(LightTiles, MemoryIsBoundedWhereEveryLightReachesEverything) {
  std::vector<Light> lights(1024, Light{.kind = LightKind::Point, .radius = 1000});
  VisibleCluster everything;
  everything.radius = 5;
  everything.pixels = {0, 0, 1280, 720};
  const LightTiles tiles = buildLightTiles(std::span(&everything, 1), lights, {0, 0, 1280, 720});
  EXPECT_LE(tiles.texels, kMostLightTexels);
  // The tiles still cover every pixel once.
  int64_t area = 0;
  for (const Tile& t : tiles.tiles) area += int64_t{t.x1 - t.x0} * (t.y1 - t.y0);
  EXPECT_EQ(area, 1280 * 720);
  // A view with several models has as much for all of them.
  EXPECT_LE(buildLightTiles(std::span(&everything, 1), lights, {0, 0, 1280, 720}, kMostLightTexels / 4).texels, kMostLightTexels / 4);
}

// The directions follow the kernel: the mean of their cosines is the kernel's.
TEST(Lobe, SamplesHaveTheKernelsMoments) {
  constexpr size_t kEntries = 1024;
  for (const double exponent : {1.0, 30.0, 900.0}) {
    std::vector<float> kernel(kEntries);
    for (size_t i = 0; i < kEntries; ++i) kernel[i] = static_cast<float>(std::pow(std::cos(lobeAngle(i, kEntries)), exponent));
    double mean = 0, sideways = 0;
    const auto samples = lobeSamples(kernel, 512, 256);
    for (const glm::vec4& s : samples) {
      EXPECT_NEAR(glm::length(glm::vec3(s)), 1, 1e-5);
      EXPECT_GE(s.w, 0);
      mean += s.z / 512;
      sideways += s.x / 512;
    }
    // The mean of cos under cos^p over the hemisphere is (p + 1) / (p + 2).
    EXPECT_NEAR(1 - mean, 1 - (exponent + 1) / (exponent + 2), 0.01 * (1 - (exponent + 1) / (exponent + 2))) << exponent;
    EXPECT_NEAR(sideways, 0, 0.02);
  }
}

TEST(Lobe, AKernelOfZerosYieldsTheAxis) {
  const auto samples = lobeSamples(std::vector<float>(64, 0.0f), 16, 256);
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(glm::vec3(samples[0]), glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace glint
