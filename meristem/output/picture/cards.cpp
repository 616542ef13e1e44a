// SPDX-License-Identifier: Apache-2.0
// In: a mesh scene with textures. Out: crossed quads with one picture (an atlas of views) that rays through the scene
// have drawn. A pixel is the mean over the hits of its rays: the unlit colour of the surface as a path tracer sees it,
// and the normal, turned toward the viewer, in the card's tangent space.
//
// Based on: P. Maciel, P. Shirley: Visual navigation of large environments using textured clusters (1995), for
// impostors; I. Castaño: Computing alpha mipmaps (2010), for masks that keep their coverage.
#include "meristem/output/picture/cards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include "meristem/base/colour.h"
#include "meristem/base/fingerprint.h"
#include "meristem/base/math.h"
#include "meristem/base/parallel.h"
#include "meristem/output/picture/texture_sampler.h"
#include "meristem/shape/detail/detail.h"
#include "meristem/shape/mesh/tangents.h"
#include "meristem/shape/rays/ray_scene.h"

namespace meristem {

namespace {

constexpr float kLevelCard = 0.6F;   // height of the level card as a share of the plant's height, inside the crown
constexpr int kGutter = 4;           // pixels between views, so that they stay separate in downscaled pictures
constexpr int kSpread = 12;          // number of pixels to which colours are spread beyond the mask
constexpr float kFootShare = 0.02F;  // height of the plant's foot, as a share of the plant's height

/// One card: its position, and the position of its view in the picture.
struct Card {
  Vec3 across, up, toward;  // unit vectors; `toward` points to the viewer
  Vec3 corner{0};           // lower left corner
  float width = 0, height = 0;
  int left = 0;               // first column of the view in the atlas, pixels
  int columns = 0, rows = 0;  // size of the view, pixels
};

/// The hits of the rays around one pixel.
struct Pixel {
  Vec3 colour{0};  // linear colour of the covered part
  Vec3 normal{0};
  float covered = 0;  // covered share
};

/// Returns the position of the plant: the middle of its lowest parts.
Vec3 foot_of(const MeshScene& scene, const Box& box) {
  const float top = box.low.y + kFootShare * box.size().y;
  Box foot;
  for (const MeshInstances& part : scene.meshes) {
    for (std::size_t i = 0; i < part.count(); ++i) {
      const Frame frame = part.frame(i);
      for (const Vec3 position : part.mesh->positions) {
        const Vec3 point = frame.point(position);
        if (point.y <= top) foot.add(point);
      }
    }
  }
  return foot.is_empty() ? box.centre() : foot.centre();
}

/// Sets the size of a card to the extent of the scene in the directions of the card.
void fit_card(const MeshScene& scene, Vec3 foot, Card& card) {
  float low_x = std::numeric_limits<float>::infinity();
  float low_y = low_x;
  float high_x = -low_x;
  float high_y = -low_x;
  for (const MeshInstances& part : scene.meshes) {
    for (std::size_t i = 0; i < part.count(); ++i) {
      const Frame frame = part.frame(i);
      for (const Vec3 position : part.mesh->positions) {
        const Vec3 offset = frame.point(position) - foot;
        const float x = glm::dot(offset, card.across);
        const float y = glm::dot(offset, card.up);
        low_x = std::min(low_x, x);
        high_x = std::max(high_x, x);
        low_y = std::min(low_y, y);
        high_y = std::max(high_y, y);
      }
    }
  }
  card.corner = foot + low_x * card.across + low_y * card.up;
  card.width = high_x - low_x;
  card.height = high_y - low_y;
}

std::vector<Card> plan_cards(const MeshScene& scene, const CardOptions& options) {
  const Box box = scene.bounds();
  const Vec3 foot = foot_of(scene, box);
  std::vector<Card> cards;
  for (int k = 0; k < options.cards; ++k) {
    const double turn = kPi * k / options.cards;
    const Vec3 across(static_cast<float>(math::cos(turn)), 0, static_cast<float>(math::sin(turn)));
    cards.push_back({across, kUp, glm::cross(across, kUp)});
  }
  // The level card shows the view from above.
  cards.push_back({Vec3(1, 0, 0), Vec3(0, 0, -1), kUp});
  float longest = 0;
  for (Card& card : cards) {
    fit_card(scene, foot, card);
    longest = std::max({longest, card.width, card.height});
  }
  // Place it inside the crown, so that it does not look like a plate from the side.
  cards.back().corner.y = box.low.y + kLevelCard * box.size().y;
  int left = kGutter;
  for (Card& card : cards) {
    const auto pixels = [&](float metres) {
      return std::max(1, static_cast<int>(std::lround(options.size * metres / std::max(longest, 1e-9F))));
    };
    card.columns = pixels(card.width);
    card.rows = pixels(card.height);
    card.left = left;
    left += card.columns + kGutter;
  }
  return cards;
}

/// Computes colours and normals at the hits of rays.
class Skin {
 public:
  Skin(const MeshScene& scene, Progress& progress) : rays_(scene, progress) {
    for (const MeshInstances& part : scene.meshes) {
      const Material& material = scene.materials[part.material];
      Look look{material.tint(), nullptr};
      if (const Texture* texture = material.texture.get(); texture != nullptr && !texture->colour.is_empty()) {
        look.texture = &textures_.try_emplace(texture, *texture).first->second;
      }
      looks_.push_back(look);
    }
  }

  /// Adds the hit of a ray that represents a beam `width` metres wide.
  void add(const Ray& ray, float width, Pixel& pixel) const {
    const auto hit = rays_.first_hit(ray);
    if (!hit) return;
    SurfacePoint point = rays_.surface_point(*hit);
    const Look& look = looks_[hit->part];
    Vec3 colour = look.tint * rays_.tint(*hit);
    if (look.texture != nullptr) colour *= textured(look, *hit, width, point);
    pixel.colour += glm::clamp(colour, Vec3(0), Vec3(1));
    // Sides that look away are seen from behind.
    const bool is_behind = glm::dot(point.face_normal, ray.direction) > 0;
    pixel.normal += is_behind ? -point.normal : point.normal;
    pixel.covered += 1;
  }

 private:
  struct Look {
    Vec3 tint;
    const TextureSampler* texture;
  };

  Vec3 textured(const Look& look, const RayHit& hit, float width, SurfacePoint& point) const {
    const TextureMapping on = rays_.texture_mapping(hit);
    const float uvs = width * on.uvs_per_metre;
    if (look.texture->has_normals()) {
      const Vec3 mapped = look.texture->normal(on.uv, uvs);
      const Vec3 along_u = on.along_u - glm::dot(on.along_u, point.normal) * point.normal;
      const Vec3 along_v = on.along_v - glm::dot(on.along_v, point.normal) * point.normal;
      point.normal = normalized_or(mapped.x * normalized_or(along_u, Vec3(0)) +
                                       mapped.y * normalized_or(along_v, Vec3(0)) + mapped.z * point.normal,
                                   point.normal);
    }
    return look.texture->colour(on.uv, uvs);
  }

  RayScene rays_;
  std::map<const Texture*, TextureSampler> textures_;  // only for lookup, never iterated, since addresses have no
                                                       // stable order
  std::vector<Look> looks_;
};

/// Returns the view of one card, rows from top to bottom.
std::vector<Pixel> draw_view(const Skin& skin, const Card& card, float reach, int samples, Progress& progress) {
  std::vector<Pixel> pixels(static_cast<std::size_t>(card.columns) * static_cast<std::size_t>(card.rows));
  const float step_x = card.width / static_cast<float>(card.columns * samples);
  const float step_y = card.height / static_cast<float>(card.rows * samples);
  const float width = std::max(step_x, step_y) * static_cast<float>(samples);
  parallel_for(static_cast<std::size_t>(card.rows), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      progress.check();
      for (int column = 0; column < card.columns; ++column) {
        Pixel& pixel = pixels[row * static_cast<std::size_t>(card.columns) + static_cast<std::size_t>(column)];
        for (int k = 0; k < samples * samples; ++k) {
          const float x = (static_cast<float>(column * samples + k % samples) + 0.5F) * step_x;
          const float y =
              card.height - (static_cast<float>(static_cast<int>(row) * samples + k / samples) + 0.5F) * step_y;
          const Vec3 on_card = card.corner + x * card.across + y * card.up;
          skin.add({.origin = on_card + reach * card.toward, .direction = -card.toward}, width, pixel);
        }
        if (pixel.covered == 0) continue;
        const Vec3 normal = normalized_or(pixel.normal, card.toward);
        pixel.normal = {glm::dot(normal, card.across), glm::dot(normal, card.up), glm::dot(normal, card.toward)};
        // A mean of normals can lean slightly away from the viewer.
        pixel.normal.z = std::max(pixel.normal.z, 0.05F);
        pixel.normal = glm::normalize(pixel.normal);
        pixel.colour *= 1 / pixel.covered;
        pixel.covered *= 1 / static_cast<float>(samples * samples);
      }
      progress.advance();
    }
  });
  return pixels;
}

/// Returns the minimum covered share of a visible pixel. With it, the number of visible pixels equals the covered area.
float min_covered(const std::vector<Pixel>& pixels) {
  std::vector<float> shares;
  double sum = 0;
  for (const Pixel& pixel : pixels) {
    if (pixel.covered == 0) continue;
    shares.push_back(pixel.covered);
    sum += static_cast<double>(pixel.covered);
  }
  if (shares.empty()) return 0.5F;
  std::sort(shares.begin(), shares.end(), std::greater<>());
  const auto seen = static_cast<std::size_t>(sum + 0.5);
  return shares[std::min(std::max<std::size_t>(seen, 1), shares.size()) - 1];
}

/// Spreads the mean colour and normal of hit pixels to their neighbours, ring by ring. Distant pixels get the mean of
/// the whole view.
void spread_colours(std::vector<Pixel>& pixels, int columns, int rows) {
  std::vector<std::uint8_t> is_known(pixels.size());
  Pixel mean;
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    is_known[k] = pixels[k].covered > 0 ? 1 : 0;
    mean.colour += pixels[k].covered * pixels[k].colour;
    mean.covered += pixels[k].covered;
  }
  for (int round = 0; round < kSpread; ++round) {
    const std::vector<std::uint8_t> before = is_known;
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        const auto at = static_cast<std::size_t>(y * columns + x);
        if (before[at] != 0) continue;
        Pixel sum;
        int count = 0;
        for (const auto& [aside, down] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
          if (x + aside < 0 || x + aside >= columns || y + down < 0 || y + down >= rows) continue;
          const auto near = static_cast<std::size_t>((y + down) * columns + x + aside);
          if (before[near] == 0) continue;
          sum.colour += pixels[near].colour;
          sum.normal += pixels[near].normal;
          ++count;
        }
        if (count == 0) continue;
        pixels[at].colour = sum.colour / static_cast<float>(count);
        pixels[at].normal = normalized_or(sum.normal, Vec3(0, 0, 1));
        is_known[at] = 1;
      }
    }
  }
  if (mean.covered > 0) mean.colour /= mean.covered;
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    if (is_known[k] != 0) continue;
    pixels[k].colour = mean.colour;
    pixels[k].normal = Vec3(0, 0, 1);
  }
}

std::uint8_t byte_of_share(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255 + 0.5F);
}

/// All views in one picture, separated by gutters.
class Atlas {
 public:
  explicit Atlas(const std::vector<Card>& cards) {
    for (const Card& card : cards) {
      columns_ = std::max(columns_, card.left + card.columns + kGutter);
      rows_ = std::max(rows_, card.rows + 2 * kGutter);
    }
    // Graphics cards compress blocks of four by four pixels.
    columns_ = (columns_ + 3) / 4 * 4;
    rows_ = (rows_ + 3) / 4 * 4;
    pixels_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  }

  void place(const Card& card, const std::vector<Pixel>& view) {
    const float min = min_covered(view);
    for (int y = 0; y < card.rows; ++y) {
      for (int x = 0; x < card.columns; ++x) {
        Pixel pixel = view[static_cast<std::size_t>(y * card.columns + x)];
        // The mask is cut at one half.
        const float share = pixel.covered;
        pixel.covered = share < min ? 0.5F * share / min : 0.5F + 0.5F * (share - min) / std::max(1 - min, 1e-6F);
        if (share >= min) pixel.covered = std::max(pixel.covered, 0.51F);
        if (share < min) pixel.covered = std::min(pixel.covered, 0.49F);
        pixels_[static_cast<std::size_t>((y + kGutter) * columns_ + card.left + x)] = pixel;
      }
    }
  }

  std::shared_ptr<const Texture> texture() {
    std::vector<Pixel> spread = pixels_;
    spread_colours(spread, columns_, rows_);
    auto texture = std::make_shared<Texture>();
    texture->name = "cards";
    texture->masked = true;
    texture->colour = {columns_, rows_, std::vector<std::uint8_t>(4 * spread.size())};
    texture->normals = texture->colour;
    DVec3 mean(0);
    double seen = 0;
    for (std::size_t k = 0; k < spread.size(); ++k) {
      const Vec3 colour = srgb_from_linear(spread[k].colour);
      const Vec3 normal = 0.5F * spread[k].normal + 0.5F;
      for (int c = 0; c < 3; ++c) {
        texture->colour.rgba[4 * k + static_cast<std::size_t>(c)] = byte_of_share(colour[c]);
        texture->normals.rgba[4 * k + static_cast<std::size_t>(c)] = byte_of_share(normal[c]);
      }
      texture->colour.rgba[4 * k + 3] = byte_of_share(spread[k].covered);
      texture->normals.rgba[4 * k + 3] = 255;
      if (spread[k].covered < 0.5F) continue;
      mean += DVec3(spread[k].colour);
      seen += 1;
    }
    if (seen > 0) texture->mean = Vec3(mean / seen);
    texture->fingerprint = Fingerprint().add_array(texture->colour.rgba).add_array(texture->normals.rgba).hash();
    return texture;
  }

  /// Returns the uv of a pixel's corner, where pixels are counted from the picture's upper left.
  Vec2 uv(int column, int row) const {
    return {static_cast<float>(column) / static_cast<float>(columns_),
            1 - static_cast<float>(row) / static_cast<float>(rows_)};
  }

 private:
  int columns_ = 0, rows_ = 0;
  std::vector<Pixel> pixels_;
};

Mesh mesh_of(const std::vector<Card>& cards, const Atlas& atlas) {
  Mesh mesh;
  for (const Card& card : cards) {
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
      mesh.positions.push_back(card.corner + static_cast<float>(x) * card.width * card.across +
                               static_cast<float>(y) * card.height * card.up);
      mesh.normals.push_back(card.toward);
      mesh.uvs.push_back(atlas.uv(card.left + x * card.columns, kGutter + (1 - y) * card.rows));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  add_tangents(mesh);
  return mesh;
}

}  // namespace

MeshScene make_cards(const MeshScene& whole, const CardOptions& options, Progress& progress) {
  if (options.cards < 1 || options.cards > kMaxCards || options.size < 8 || options.size > 8192 ||
      options.samples < 1 || options.samples > 64) {
    throw std::invalid_argument("cards out of range");
  }
  MeshScene scene;
  if (whole.triangle_count() == 0) return scene;
  const std::vector<Card> cards = plan_cards(whole, options);
  std::uint64_t rows = 0;
  for (const Card& card : cards) rows += static_cast<std::uint64_t>(card.rows);
  progress.begin("drawing cards", rows);
  const Skin skin(whole, progress);
  const float reach = 2 * glm::length(whole.bounds().size()) + 1;
  Atlas atlas(cards);
  for (const Card& card : cards) atlas.place(card, draw_view(skin, card, reach, options.samples, progress));

  Material material;
  material.name = "cards";
  material.two_sided = true;
  material.roughness = 0.8F;
  material.texture = atlas.texture();
  material.colour = srgb_from_linear(material.texture->mean);
  scene.materials.push_back(std::move(material));
  scene.meshes.push_back({"cards", std::make_shared<const Mesh>(mesh_of(cards, atlas)), 0, {Frame{}}, {}});
  return scene;
}

}  // namespace meristem
