package org.palpate.io.scene;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The tool of a scene file.
 *
 * @param spec the tool as in {@code --tool}; the name of a file is relative to the scene file
 * @param segment the voxels of a tool from a volume file as in {@code --tool-segment}
 * @param clearance the clearance as in {@code --clearance}
 * @param massKg the mass, kg
 */
public record SceneTool(
    String spec, Optional<String> segment, Optional<String> clearance, OptionalDouble massKg) {

  /** Whether the tool is a file, and neither a point nor a shape with numbers. */
  public boolean isFile() {
    return spec.indexOf(':') < 0 && !spec.equals("point");
  }

  /** Returns this tool with another spec. */
  public SceneTool with(String newSpec) {
    return new SceneTool(newSpec, segment, clearance, massKg);
  }
}
