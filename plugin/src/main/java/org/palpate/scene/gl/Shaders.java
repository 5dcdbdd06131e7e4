package org.palpate.scene.gl;

/** The sources of the shader programs, without their version line. */
final class Shaders {
  private Shaders() {}

  /**
   * Light in the camera's frame: a key light from the upper left, a fill light, a rim and the sky
   * above.
   */
  private static final String LIGHT =
      """
      vec3 linear(vec3 c) { return pow(c, vec3(2.2)); }
      vec3 lit(vec3 colour, vec3 n, vec3 toEye, float open, float shine) {
        vec3 key = normalize(vec3(-0.45, 0.55, 0.70));
        vec3 fill = normalize(vec3(0.75, 0.05, 0.60));
        float k = max(dot(n, key), 0.0);
        float f = max(dot(n, fill), 0.0);
        float sky = 0.5 + 0.5 * n.y;
        vec3 ambient = mix(vec3(0.11, 0.10, 0.095), vec3(0.25, 0.27, 0.30), sky);
        float shade = mix(0.35, 1.0, open);
        vec3 light = ambient * open * open
            + vec3(1.00, 0.97, 0.92) * 0.92 * k * shade
            + vec3(0.80, 0.88, 1.00) * 0.24 * f * open;
        vec3 h = normalize(key + toEye);
        float spec = pow(max(dot(n, h), 0.0), 42.0) * shine * open * step(0.0, k - 0.001);
        float rim = pow(1.0 - max(dot(n, toEye), 0.0), 3.0) * 0.10 * open;
        return colour * light + vec3(spec) + vec3(0.75, 0.85, 1.0) * rim;
      }
      vec3 shown(vec3 c) { return pow(clamp(c, 0.0, 1.0), vec3(1.0 / 2.2)); }
      """;

  /**
   * The displacement of a point in grid mm by the lattice of {@link DeformationTexture}. Positions
   * are those of {@code DeformationMap}: affine on the Kuhn tetrahedra of each cell. The gradient
   * comes from differences over a cell, so that normals do not jump at a tetrahedron's face.
   */
  static final String DISPLACEMENT =
      """
      uniform bool deforms;
      uniform sampler3D displacements;
      uniform vec3 latticeOrigin;
      uniform vec3 latticeCell;
      uniform vec3 latticeCells;
      // A box in the lattice with shorter cells.
      uniform bool windowed;
      uniform sampler3D windowDisplacements;
      uniform vec3 windowOrigin;
      uniform vec3 windowCell;
      uniform vec3 windowCells;
      vec3 displacementOf(sampler3D nodes, vec3 at, vec3 cells) {
        vec3 first = min(floor(at), cells - 1.0);
        vec3 f = at - first;
        ivec3 cell = ivec3(first);
        ivec3 longest = f.x >= f.y && f.x >= f.z ? ivec3(1, 0, 0)
            : f.y >= f.z ? ivec3(0, 1, 0) : ivec3(0, 0, 1);
        ivec3 shortest = f.z <= f.x && f.z <= f.y ? ivec3(0, 0, 1)
            : f.y <= f.x ? ivec3(0, 1, 0) : ivec3(1, 0, 0);
        float high = max(f.x, max(f.y, f.z));
        float low = min(f.x, min(f.y, f.z));
        float middle = f.x + f.y + f.z - high - low;
        return (1.0 - high) * texelFetch(nodes, cell, 0).xyz
            + (high - middle) * texelFetch(nodes, cell + longest, 0).xyz
            + (middle - low) * texelFetch(nodes, cell + 1 - shortest, 0).xyz
            + low * texelFetch(nodes, cell + 1, 0).xyz;
      }
      bool inWindow(vec3 position) {
        vec3 at = (position - windowOrigin) / windowCell;
        return windowed && all(greaterThanEqual(at, vec3(0))) && all(lessThanEqual(at, windowCells));
      }
      vec3 displacement(vec3 position) {
        if (inWindow(position)) {
          vec3 at = (position - windowOrigin) / windowCell;
          return displacementOf(windowDisplacements, at, windowCells);
        }
        vec3 at = clamp((position - latticeOrigin) / latticeCell, vec3(0), latticeCells);
        return displacementOf(displacements, at, latticeCells);
      }
      vec3 stretched(vec3 position, vec3 axis) {
        vec3 cell = inWindow(position) ? windowCell : latticeCell;
        vec3 aside = 0.5 * cell * axis;
        vec3 difference = displacement(position + aside) - displacement(position - aside);
        return axis + difference / dot(cell, axis);
      }
      // The normal times the cofactors of the deformation gradient.
      vec3 deformedNormal(vec3 position, vec3 normal) {
        vec3 x = stretched(position, vec3(1, 0, 0));
        vec3 y = stretched(position, vec3(0, 1, 0));
        vec3 z = stretched(position, vec3(0, 0, 1));
        return normal.x * cross(y, z) + normal.y * cross(z, x) + normal.z * cross(x, y);
      }
      """;

  static final String MESH_VERTEX =
      DISPLACEMENT
          + """
          layout(location = 0) in vec3 position;
          layout(location = 1) in vec4 normalAndVisibility;
          uniform mat4 toEye;
          uniform mat4 projection;
          out vec3 eyePosition;
          out vec3 eyeNormal;
          out float visibility;
          out vec3 gridPosition;
          // Which value colours the surface, see DeformationColour, and its largest one.
          uniform int deformedBy;
          uniform float deformedMost;
          out float deformed;
          // The equivalent strain; its columns are those of the deformation gradient.
          float strain(vec3 x, vec3 y, vec3 z) {
            vec3 normal = 0.5 * (vec3(dot(x, x), dot(y, y), dot(z, z)) - 1.0);
            vec3 shear = 0.5 * vec3(dot(y, z), dot(z, x), dot(x, y));
            normal -= dot(normal, vec3(1.0 / 3.0));
            return sqrt((dot(normal, normal) + 2.0 * dot(shear, shear)) * 2.0 / 3.0);
          }
          float deformedAt(vec3 position) {
            if (deformedBy == 1) return length(displacement(position));
            if (deformedBy == 0) return 0.0;
            return strain(stretched(position, vec3(1, 0, 0)), stretched(position, vec3(0, 1, 0)),
                stretched(position, vec3(0, 0, 1)));
          }
          void main() {
            gridPosition = position;
            deformed = 0.0;
            vec3 present = position;
            vec3 normal = normalAndVisibility.xyz;
            if (deforms) {
              present += displacement(position);
              normal = deformedNormal(position, normal);
              deformed = deformedAt(position) / deformedMost;
            }
            vec4 p = toEye * vec4(present, 1);
            eyePosition = p.xyz;
            eyeNormal = mat3(toEye) * normal;
            visibility = normalAndVisibility.w;
            gl_Position = projection * p;
          }
          """;

  static final String MESH_FRAGMENT =
      LIGHT
          + """
          in vec3 eyePosition;
          in vec3 eyeNormal;
          in float visibility;
          in vec3 gridPosition;
          in float deformed;
          uniform vec3 colour;
          uniform float opacity;
          // What lies farther along the normal, both in the camera's frame, is hidden.
          uniform vec3 clipNormal;
          uniform float clipDistance;
          // A measured value in a box, see SurfaceTint.
          uniform sampler3D tint;
          uniform int tinted;
          uniform vec3 tintLow;
          uniform vec3 tintSize;
          out vec4 result;
          vec3 viridis(float value) {
            vec3 c[5] = vec3[5](vec3(0.267, 0.005, 0.329), vec3(0.231, 0.318, 0.545),
                vec3(0.129, 0.569, 0.549), vec3(0.369, 0.788, 0.384), vec3(0.993, 0.906, 0.144));
            float at = clamp(value, 0.0, 1.0) * 4.0;
            int low = min(int(at), 3);
            return mix(c[low], c[low + 1], at - float(low));
          }
          vec3 ownColour() {
            return mix(colour, viridis(deformed), smoothstep(0.01, 0.05, deformed));
          }
          vec3 surfaceColour() {
            vec3 place = (gridPosition - tintLow) / tintSize;
            bool isIn = all(greaterThan(place, vec3(0))) && all(lessThan(place, vec3(1)));
            if (tinted == 0 || !isIn) return ownColour();
            vec2 found = texture(tint, place).rg;
            return mix(ownColour(), viridis(found.r / max(found.g, 0.004)), smoothstep(0.2, 0.6, found.g));
          }
          void main() {
            if (dot(clipNormal, eyePosition) > clipDistance) discard;
            vec3 toEye = normalize(-eyePosition);
            vec3 n = normalize(eyeNormal);
            bool inside = !gl_FrontFacing;
            if (inside) n = -n;
            vec3 c = lit(linear(surfaceColour()), n, toEye, clamp(visibility, 0.0, 1.0), inside ? 0.0 : 0.16);
            if (inside) c *= 0.6;
            // Transparent surfaces are most visible at their rim.
            float rim = pow(1.0 - max(dot(n, toEye), 0.0), 2.0);
            float cover = opacity < 1.0 ? min(1.0, opacity * mix(0.5, 2.0, rim)) : 1.0;
            result = vec4(shown(c), cover);
          }
          """;

  static final String MARK_VERTEX =
      """
      layout(location = 0) in vec3 position;
      layout(location = 1) in vec3 normal;
      layout(location = 2) in vec4 colour;
      uniform mat4 toEye;
      uniform mat4 projection;
      uniform float nearer;
      out vec3 eyePosition;
      out vec3 eyeNormal;
      out vec4 tint;
      void main() {
        vec4 p = toEye * vec4(position, 1);
        eyePosition = p.xyz;
        eyeNormal = mat3(toEye) * normal;
        tint = colour;
        // A shift towards the eye, which is the origin, keeps the position in the picture.
        vec3 place = p.xyz * (1.0 - nearer / max(length(p.xyz), 2.0 * nearer + 1e-9));
        gl_Position = projection * vec4(place, 1);
      }
      """;

  static final String MARK_FRAGMENT =
      LIGHT
          + """
          in vec3 eyePosition;
          in vec3 eyeNormal;
          in vec4 tint;
          uniform float opacity;
          out vec4 result;
          void main() {
            vec3 n = normalize(eyeNormal);
            vec3 c = lit(linear(tint.rgb) * 1.25, n, normalize(-eyePosition), 1.0, 0.35);
            result = vec4(shown(c), tint.a * opacity);
          }
          """;

  /** A triangle that covers the picture; {@code place} runs from 0 to 1. */
  static final String SCREEN_VERTEX =
      """
      out vec2 place;
      void main() {
        place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
        gl_Position = vec4(place * 2.0 - 1.0, 1.0, 1.0);
      }
      """;

  static final String BACKGROUND_FRAGMENT =
      """
      in vec2 place;
      uniform vec3 above;
      uniform vec3 below;
      out vec4 result;
      void main() {
        float d = length((place - vec2(0.5, 0.55)) * vec2(1.1, 1.0));
        vec3 c = mix(above, below, smoothstep(0.0, 0.85, d));
        result = vec4(c, 1);
      }
      """;

  /** Shows a drawn picture; each pixel is the mean of {@code scale} squared samples. */
  static final String PRESENT_FRAGMENT =
      """
      in vec2 place;
      uniform sampler2D picture;
      uniform int scale;
      uniform vec2 corner;
      uniform int eye;
      out vec4 result;
      void main() {
        ivec2 from = ivec2(gl_FragCoord.xy - corner) * scale;
        vec3 sum = vec3(0);
        for (int y = 0; y < scale; y++)
          for (int x = 0; x < scale; x++)
            sum += texelFetch(picture, from + ivec2(x, y), 0).rgb;
        vec3 c = sum / float(scale * scale);
        float grey = dot(c, vec3(0.299, 0.587, 0.114));
        if (eye != 0) c = mix(vec3(grey), c, 0.5);
        result = vec4(c, 1);
      }
      """;

  static final String FLAT_VERTEX =
      """
      layout(location = 0) in vec2 position;
      layout(location = 1) in vec2 texture;
      layout(location = 2) in vec4 colour;
      uniform vec2 size;
      out vec2 at;
      out vec4 tint;
      void main() {
        at = texture;
        tint = colour;
        gl_Position = vec4(position / size * vec2(2, -2) + vec2(-1, 1), 0, 1);
      }
      """;

  /**
   * Letters and panels; the texture coordinate -1 stands for a panel. Rounding may make that of a
   * letter slightly negative.
   */
  static final String FLAT_FRAGMENT =
      """
      in vec2 at;
      in vec4 tint;
      uniform sampler2D atlas;
      out vec4 result;
      void main() {
        float cover = at.x < -0.5 ? 1.0 : texture(atlas, at).r;
        result = vec4(tint.rgb, tint.a * cover);
      }
      """;

  static final String SLICE_VERTEX =
      DISPLACEMENT
          + """
          layout(location = 0) in vec3 position;
          layout(location = 1) in vec2 texture;
          uniform mat4 toEye;
          uniform mat4 projection;
          out vec2 at;
          void main() {
            vec3 present = deforms ? position + displacement(position) : position;
            at = texture;
            gl_Position = projection * toEye * vec4(present, 1);
          }
          """;

  static final String SLICE_FRAGMENT =
      """
      in vec2 at;
      uniform sampler2D slice;
      out vec4 result;
      void main() {
        float grey = texture(slice, at).r;
        if (grey < 0.08) discard;
        result = vec4(vec3(grey), 1);
      }
      """;
}
