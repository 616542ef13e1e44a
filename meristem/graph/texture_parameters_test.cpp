// SPDX-License-Identifier: Apache-2.0
#include "meristem/graph/texture_parameters.h"

#include <gtest/gtest.h>

#include "meristem/base/diagnostic.h"
#include "meristem/graph/table/reader.h"

namespace meristem::texture_parameters_test {

struct Result {
  TextureParameters form;
  std::vector<Diagnostic> errors;
};

Result read(const Value& value, const std::string& folder = {}) {
  Result result;
  ParameterReader reader({}, SizeLimits{}, {.folder = folder});
  const DocumentPath top;
  reader.read(texture_table(), &result.form, value, DocumentPath(top, "texture"));
  result.errors = reader.take_diagnostics();
  return result;
}

std::string error(const Value& value) {
  const Result result = read(value);
  return result.errors.empty() ? "no fault" : result.errors[0].text();
}

TextureParameters bark_form(int pixels = 32) {
  TextureParameters form;
  form.bark = BarkRecipe{.style = BarkRecipe::Style::plated};
  form.pixels = pixels;
  return form;
}

/// A picture of one colour with an alpha.
Asset<Image> picture(std::uint8_t red, std::uint8_t alpha) {
  Image image{2, 1, {red, 0, 0, 255, red, 0, 0, alpha}};
  return {"a.png", std::make_shared<const Image>(std::move(image))};
}

TEST(TextureParameters, ReadsEachKindAndItsShorthand) {
  const Result bark = read(Value::Object{{"bark", "peeling"}, {"pixels", 64}});
  ASSERT_TRUE(bark.form.bark);
  EXPECT_EQ(bark.form.bark->style, BarkRecipe::Style::peeling);
  EXPECT_EQ(bark.form.pixels, 64);

  const Result leaf = read(Value::Object{{"leaf", Value::Object{{"veins", "palmate"}, {"pairs", 2}, {"angle", 60}}}});
  ASSERT_TRUE(leaf.form.leaf);
  EXPECT_EQ(leaf.form.leaf->veins, LeafRecipe::Veins::palmate);
  EXPECT_EQ(leaf.form.leaf->pairs, 2);
  EXPECT_NEAR(leaf.form.leaf->angle, radians(60), 1e-12);

  const Result petal = read(Value::Object{{"petal", Value::Object{{"throat", "#ffff00"}}}});
  ASSERT_TRUE(petal.form.petal);
  EXPECT_EQ(petal.form.petal->throat, Vec3(1, 1, 0));
}

TEST(TextureParameters, RefusesTwoKindsAtOnce) {
  EXPECT_NE(error(Value::Object{{"bark", "smooth"}, {"leaf", "pinnate"}}), "no fault");
  EXPECT_NE(error(Value::Object{{"leaf", "pinnate"}, {"petal", Value::Object{}}}), "no fault");
  EXPECT_EQ(error(Value::Object{{"bark", "smooth"}}), "no fault");
}

TEST(TextureParameters, RefusesUnknownStylesWithTheNearest) {
  EXPECT_EQ(error(Value::Object{{"bark", "furowed"}}),
            "texture.bark: 'furowed' is not a value of 'style'; expected one of smooth, furrowed, plated, peeling; did "
            "you mean "
            "'furrowed'?");
}

TEST(TextureParameters, RefusesPicturesThatAreNotThere) {
  EXPECT_NE(error(Value::Object{{"picture", "no-such-picture.png"}}).find("there is no such file"), std::string::npos);
  EXPECT_NE(error(Value::Object{{"picture", Value::Object{{"masked", true}}}}), "no fault");
}

TEST(TextureParameters, WithoutAKindMakesNone) { EXPECT_EQ(make_texture({}, {}, Vec3(0.5F)), nullptr); }

TEST(TextureParameters, EqualOnesHaveTheSameFingerprint) {
  const auto fingerprint = [](const TextureParameters& form, const TextureShape& shape = {}, Vec3 colour = Vec3(0.5F)) {
    return sketch_texture(form, shape, colour)->fingerprint;
  };
  const std::uint64_t first = fingerprint(bark_form());
  EXPECT_EQ(fingerprint(bark_form()), first);
  // Bark follows no shape.
  EXPECT_EQ(fingerprint(bark_form(), {.masked = true}), first);
  EXPECT_NE(fingerprint(bark_form(), {}, Vec3(0.4F)), first);
  EXPECT_NE(fingerprint(bark_form(33)), first);
  TextureParameters other = bark_form();
  other.bark->seed = 2;
  EXPECT_NE(fingerprint(other), first);
  other = bark_form();
  other.bark->marks = Vec3(0);
  EXPECT_NE(fingerprint(other), first);
}

TextureParameters leaf_form(double relief = 1) {
  TextureParameters form;
  form.leaf = LeafRecipe{.relief = relief};
  form.pixels = 32;
  return form;
}

TextureParameters petal_form() {
  TextureParameters form;
  form.petal = PetalRecipe{};
  form.pixels = 16;
  return form;
}

TextureParameters picture_form(bool masked) {
  TextureParameters form;
  form.picture = PictureParameters{.colour = picture(100, 0), .normals = picture(128, 255), .masked = masked};
  return form;
}

TEST(TextureParameters, ASketchSaysAllOfATextureButItsPixels) {
  const TextureShape cut{{{0, 0}, {1, 0}, {0.5F, 1}}, true};
  for (const TextureParameters& form :
       {bark_form(), leaf_form(), leaf_form(0), petal_form(), picture_form(false), picture_form(true)}) {
    for (const TextureShape& shape : {TextureShape(), cut}) {
      const auto sketch = sketch_texture(form, shape, Vec3(0.5F));
      const auto painted = make_texture(form, shape, Vec3(0.5F));
      EXPECT_FALSE(sketch->is_painted());
      EXPECT_TRUE(painted->is_painted());
      EXPECT_EQ(sketch->bytes(), 0U);
      EXPECT_EQ(sketch->fingerprint, painted->fingerprint);
      EXPECT_EQ(sketch->masked, painted->masked);
      EXPECT_EQ(sketch->has_normals(), painted->has_normals());
      EXPECT_EQ(sketch->colour.width, painted->colour.width);
      EXPECT_EQ(sketch->colour.height, painted->colour.height);
      EXPECT_EQ(sketch->normals.width, painted->normals.width);
      if (form.picture) {
        EXPECT_EQ(sketch->mean, painted->mean);
      }
    }
  }
}

TEST(TextureParameters, LeavesFollowTheShape) {
  const TextureParameters form = leaf_form();
  const auto whole = make_texture(form, {}, Vec3(0.5F));
  const auto cut = make_texture(form, {{{0, 0}, {1, 0}, {0.5F, 1}}, true}, Vec3(0.5F));
  EXPECT_FALSE(whole->masked);
  EXPECT_TRUE(cut->masked);
  EXPECT_EQ(cut->colour.pixel(0, 0)[3], 0);
}

TEST(TextureParameters, PicturesHaveTheirOwnMean) {
  TextureParameters form;
  form.picture = PictureParameters{.colour = picture(255, 0)};
  const auto opaque = make_texture(form, {}, Vec3(0.5F));
  EXPECT_EQ(opaque->mean, Vec3(1, 0, 0));
  EXPECT_FALSE(opaque->masked);
  EXPECT_EQ(opaque->colour.pixel(1, 0)[3], 255);
  EXPECT_FALSE(opaque->has_normals());

  form.picture->masked = true;
  const auto masked = make_texture(form, {}, Vec3(0.5F));
  EXPECT_NE(masked->fingerprint, opaque->fingerprint);
  EXPECT_EQ(masked->colour.pixel(1, 0)[3], 0);
}

TEST(TextureParameters, PicturesAreLaidAsTheFormSays) {
  TextureParameters form;
  Mesh mesh;
  mesh.uvs = {{0, 0}, {1, 0.5F}};
  const std::vector<Vec2> before = mesh.uvs;
  lay_picture(form, mesh);
  EXPECT_EQ(mesh.uvs, before);
  form.picture = PictureParameters{.colour = picture(255, 255)};
  lay_picture(form, mesh);
  EXPECT_EQ(mesh.uvs, before);
  form.picture->repeat_u = 2;
  form.picture->repeat_v = -1;
  form.picture->shift_v = 0.25;
  lay_picture(form, mesh);
  EXPECT_EQ(mesh.uvs, (std::vector<Vec2>{{0, 0.25F}, {2, -0.25F}}));
}

TEST(TextureParameters, PicturesOfTheSamePixelsHaveTheSameFingerprint) {
  const auto fingerprint = [](const TextureParameters& form, Vec3 colour) {
    return sketch_texture(form, {}, colour)->fingerprint;
  };
  TextureParameters one;
  one.picture = PictureParameters{.colour = picture(100, 255)};
  TextureParameters two;
  two.picture = PictureParameters{.colour = picture(100, 255)};
  const std::uint64_t first = fingerprint(one, Vec3(0.5F));
  EXPECT_EQ(fingerprint(two, Vec3(0.1F)), first);
  two.picture->colour = picture(101, 255);
  EXPECT_NE(fingerprint(two, Vec3(0.5F)), first);
  two.picture->colour = one.picture->colour;
  two.picture->normals = picture(128, 255);
  EXPECT_NE(fingerprint(two, Vec3(0.5F)), first);
}

}  // namespace meristem::texture_parameters_test
