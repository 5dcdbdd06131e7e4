package org.palpate.io.scene;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.body.Mobility;

/**
 * The content of a scene file.
 *
 * @param bodies the bodies in the order in which results number them; at least one
 * @param fills elastic matter that cannot be touched, after the bodies
 * @param tool the tool; empty for a point
 * @param device the mapping of the device
 * @param protect what cutting spares
 * @param carve the rate of cutting, mm^3 for each N s; empty if nothing is cut
 */
public record SceneFile(
    List<SceneBody> bodies,
    List<SceneFill> fills,
    Optional<SceneTool> tool,
    Optional<SceneDevice> device,
    List<String> protect,
    OptionalDouble carve) {
  /** The version of the format, which files may state. */
  public static final int VERSION = 1;

  /** Copies the lists. */
  public SceneFile {
    bodies = List.copyOf(bodies);
    fills = List.copyOf(fills);
    protect = List.copyOf(protect);
  }

  /** Whether a body is elastic. */
  public boolean isElastic() {
    return bodies.stream().anyMatch(body -> body.mobility() == Mobility.ELASTIC);
  }

  /** Returns a scene of bodies and a point tool. */
  public static SceneFile ofBodies(List<SceneBody> bodies) {
    return new SceneFile(
        bodies, List.of(), Optional.empty(), Optional.empty(), List.of(), OptionalDouble.empty());
  }

  /** Returns this scene with other bodies and another tool. */
  public SceneFile with(List<SceneBody> newBodies, Optional<SceneTool> newTool) {
    return new SceneFile(newBodies, fills, newTool, device, protect, carve);
  }

  /** Returns this scene with other bodies and other fills. */
  public SceneFile with(List<SceneBody> newBodies, List<SceneFill> newFills) {
    return new SceneFile(newBodies, newFills, tool, device, protect, carve);
  }
}
