package org.palpate.io.scene;

import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.geometry.Vec3;

/**
 * The mapping of a device into the world of a scene file.
 *
 * @param scale world mm for each mm of the device
 * @param axes the axes of the device as in {@code --axes}: {@link #PATIENT} or {@link #VIEW}
 * @param offsetMm the world position of the middle of the device's workspace, mm; not to be written
 */
public record SceneDevice(OptionalDouble scale, Optional<String> axes, Optional<Vec3> offsetMm) {
  /** The axes of a person who faces the patient. */
  public static final String PATIENT = "patient";

  /** The axes of the picture. */
  public static final String VIEW = "view";
}
