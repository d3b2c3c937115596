#pragma once

namespace pleura::shaders {

/// Vertices of items, to view space and to clip space. `invariant`, because depth peeling draws every surface
/// twice and compares depths for equality.
inline constexpr const char* surfaceVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
uniform mat4 projection;
uniform mat4 modelView;
uniform mat3 normalMatrix;
invariant gl_Position;
out vec3 viewPosition;
out vec3 viewNormal;
out vec4 vertexColor;

void main() {
  vec4 p = modelView * vec4(position, 1);
  viewPosition = p.xyz;
  viewNormal = normalMatrix * normal;
  vertexColor = color;
  gl_Position = projection * p;
}
)";

/// X3D 4.0 lighting (ISO/IEC 19775-1, 17.2.2.4) in view space, where the viewer is at the origin:
/// I = O_E + sum over lights of attenuation * spot * I_L * (ambient + diffuse + specular).
/// What an item does not need is left out when its variant is compiled; software OpenGL pays for every
/// branch: LIGHTS, lightKind[] (0 directional, 1 point, 2 spot, 3 off) and the flags LIT SPECULAR FACETED
/// COLORED PARALLEL.
inline constexpr const char* surfaceFragment = R"(
struct Light {
  vec4 colorIntensity;
  vec4 direction;
  vec4 locationRadius;
  vec4 attenuationAmbient;
  vec4 beamWidthCutOffAngle;
};
layout(std140) uniform Lights { Light lights[16]; };
uniform vec4 diffuseAlpha;
uniform vec4 specularExponent;
uniform vec4 emissiveAmbient;
in vec3 viewPosition;
in vec3 viewNormal;
in vec4 vertexColor;

vec3 surfaceNormal() {
  if (FACETED) return normalize(cross(dFdx(viewPosition), dFdy(viewPosition)));
  vec3 n = viewNormal * inversesqrt(max(dot(viewNormal, viewNormal), 1e-30));
  return gl_FrontFacing ? n : -n;
}

vec3 shine(Light light, int kind, vec3 N, vec3 V, vec3 diffuse) {
  vec3 L = -light.direction.xyz;
  float strength = 1;
  if (kind >= 1) {
    vec3 toLight = light.locationRadius.xyz - viewPosition;
    float d = length(toLight);
    L = toLight / max(d, 1e-20);
    vec3 c = light.attenuationAmbient.xyz;
    strength = d > light.locationRadius.w ? 0 : 1 / max(c.x + c.y * d + c.z * d * d, 1);
  }
  if (kind == 2) {
    float beamWidth = light.beamWidthCutOffAngle.x, cutOffAngle = light.beamWidthCutOffAngle.y;
    float spotAngle = acos(clamp(dot(-L, light.direction.xyz), -1, 1));
    float spot = clamp((spotAngle - cutOffAngle) / min(beamWidth - cutOffAngle, -1e-6), 0, 1);
    strength *= spotAngle <= beamWidth ? 1 : spot;
  }
  float NL = dot(N, L);
  vec3 ambient = light.attenuationAmbient.w * emissiveAmbient.w * diffuse;
  vec3 reflected = max(NL, 0) * diffuse;
  if (SPECULAR && NL > 0)
    reflected += specularExponent.rgb * pow(max(dot(N, normalize(L + V)), 0), specularExponent.a);
  return strength * light.colorIntensity.rgb * (ambient + light.colorIntensity.a * reflected);
}

vec4 surfaceColor() {
  if (!LIT) return COLORED ? vertexColor : vec4(emissiveAmbient.rgb, diffuseAlpha.a);
  vec4 diffuse = COLORED ? vertexColor : diffuseAlpha;
  vec3 N = surfaceNormal(), V = PARALLEL ? vec3(0, 0, 1) : normalize(-viewPosition), I = emissiveAmbient.rgb;
  for (int i = 0; i < LIGHTS; ++i)
    if (lightKind[i] != 3) I += shine(lights[i], lightKind[i], N, V, diffuse.rgb);
  return vec4(min(I, 1), diffuse.a);
}
)";

inline constexpr const char* surfaceOutput = R"(
out vec4 pixel;

void main() { pixel = surfaceColor(); }
)";

/// Lets pass what lies in front of the layer peeled before, sample by sample.
inline constexpr const char* peelFragment = R"(
uniform sampler2DMS previousDepth;

void main() {
  if (gl_FragCoord.z >= texelFetch(previousDepth, ivec2(gl_FragCoord.xy), SAMPLE).r) discard;
}
)";

/// The lists of FragmentLists, one a pixel; 0 ends a list, i stands for fragments[i - 1].
inline constexpr const char* fragmentListBuffers = R"(
struct Fragment {
  uint color;  // RGBA, 8 bits each
  float depth;
  uint coverage;  // bit s: sample s
  uint next;
};
layout(std430, binding = 0) buffer Heads { uint heads[]; };
layout(std430, binding = 1) buffer Fragments {
  uint count;
  uint capacity;
  uint width;
  uint padding;
  Fragment fragments[];
};

uint pixelIndex() { return uint(gl_FragCoord.y) * width + uint(gl_FragCoord.x); }
)";

inline constexpr const char* fragmentListOutput = R"(
layout(early_fragment_tests) in;

void main() {
  uint color = packUnorm4x8(surfaceColor());
  uint i = atomicAdd(count, 1u) + 1u;
  if (i > capacity) return;
  uint next = atomicExchange(heads[pixelIndex()], i);
  fragments[i - 1u] = Fragment(color, gl_FragCoord.z, uint(gl_SampleMaskIn[0]), next);
}
)";

/// Blends a pixel's list from the farthest, BATCH fragments a walk through the list: they are sorted in
/// registers, which software OpenGL needs to be fast, and no list is too long. Fragments of one depth follow
/// in the order they were drawn.
inline constexpr const char* fragmentListBlend = R"(
const int BATCH = 8;
uniform sampler2DMS opaqueColor;
uniform sampler2DMS opaqueDepth;
out vec4 pixel;
vec3 C[SAMPLES];
float opaque[SAMPLES];
float depths[BATCH];  // falling; below 0 where there is no fragment
uint found[BATCH];

/// Finds the farthest fragments that stand before fragment `last`.
void findBatch(uint head, uint last, float lastDepth) {
  for (int j = 0; j < BATCH; ++j) depths[j] = -1;
  for (uint next, i = head; i != 0u; i = next) {
    next = fragments[i - 1u].next;
    uint n = i;
    float z = fragments[i - 1u].depth;
    if (!(z < lastDepth || (z == lastDepth && i > last))) z = -1;
    for (int j = 0; j < BATCH; ++j) {
      bool before = z >= depths[j];
      float shiftedDepth = before ? depths[j] : z;
      uint shifted = before ? found[j] : n;
      depths[j] = before ? z : depths[j];
      found[j] = before ? n : found[j];
      z = shiftedDepth;
      n = shifted;
    }
  }
}

void blend(uint i, float z) {
  vec4 c = unpackUnorm4x8(fragments[i - 1u].color);
  uint coverage = fragments[i - 1u].coverage;
  for (int s = 0; s < SAMPLES; ++s)
    C[s] = mix(C[s], c.rgb, (coverage >> s & 1u) != 0u && z < opaque[s] ? c.a : 0);
}

void main() {
  uint head = heads[pixelIndex()];
  if (head == 0u) discard;
  for (int s = 0; s < SAMPLES; ++s) {
    C[s] = texelFetch(opaqueColor, ivec2(gl_FragCoord.xy), s).rgb;
    opaque[s] = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), s).r;
  }
  uint last = 0u;
  float lastDepth = 2;
  do {
    findBatch(head, last, lastDepth);
    for (int j = 0; j < BATCH; ++j)
      if (depths[j] >= 0) blend(found[j], depths[j]);
    last = found[BATCH - 1];
    lastDepth = depths[BATCH - 1];
  } while (lastDepth >= 0);
  vec3 sum = vec3(0);
  for (int s = 0; s < SAMPLES; ++s) sum += C[s];
  pixel = vec4(sum / SAMPLES, 1);
}
)";

/// A triangle over the whole picture, at the far plane, with no vertex data.
inline constexpr const char* wholePictureVertex = R"(
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
  gl_Position = vec4(corner, 1, 1);
}
)";

/// The same with the direction seen at each pixel.
inline constexpr const char* backgroundVertex = R"(
uniform vec2 tangents;  // of half the picture's width and height
uniform mat3 rotation;  // view to background space
out vec3 direction;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
  direction = rotation * vec3(corner * tangents, -1);
  gl_Position = vec4(corner, 1, 1);
}
)";

inline constexpr const char* backgroundFragment = R"(
uniform int skyCount;
uniform int groundCount;
uniform vec4 sky[STOPS];     // colour and the angle from the zenith where it is pure
uniform vec4 ground[STOPS];  // colour and the angle from the nadir
in vec3 direction;
out vec4 pixel;

vec3 mixBetween(vec4 a, vec4 b, float angle) {
  return mix(a.rgb, b.rgb, clamp((angle - a.a) / max(b.a - a.a, 1e-6), 0, 1));
}

void main() {
  float fromZenith = acos(clamp(direction.y / length(direction), -1, 1)), fromNadir = 3.14159265 - fromZenith;
  vec3 color = sky[0].rgb;
  for (int i = 1; i < skyCount; ++i)
    if (fromZenith >= sky[i - 1].a) color = mixBetween(sky[i - 1], sky[i], fromZenith);
  for (int i = 1; i < groundCount; ++i)
    if (fromNadir >= ground[i - 1].a && fromNadir <= ground[groundCount - 1].a)
      color = mixBetween(ground[i - 1], ground[i], fromNadir);
  pixel = vec4(color, 1);
}
)";

/// A textured rectangle in pixels, from the picture's top left corner.
inline constexpr const char* overlayVertex = R"(
uniform vec4 rectangle;  // left, top, width, height
uniform vec2 picture;
out vec2 texel;

void main() {
  texel = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 p = (rectangle.xy + texel * rectangle.zw) / picture;
  gl_Position = vec4(2 * p.x - 1, 1 - 2 * p.y, 0, 1);
}
)";

inline constexpr const char* overlayFragment = R"(
uniform sampler2D coverage;
uniform vec4 color;
in vec2 texel;
out vec4 pixel;

void main() { pixel = vec4(color.rgb, color.a * texture(coverage, texel).r); }
)";

}  // namespace pleura::shaders
