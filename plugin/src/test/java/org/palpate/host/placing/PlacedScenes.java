package org.palpate.host.placing;

import java.util.Optional;
import org.palpate.device.SimulatedDevice;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SessionSettings;
import org.palpate.host.ToolScene;
import org.palpate.host.TouchSession;
import org.palpate.io.scene.PlacedVolume;

/** Makes scenes and sessions of placed bodies, which a point touches. */
public final class PlacedScenes {
  private PlacedScenes() {}

  /** Returns the scene of placed bodies. */
  public static ToolScene scene(PlacedVolume bodies) {
    return ToolScene.ofPoint(
        new ContactScene(
            bodies.rest(), bodies.placements(), ContactSettings.standard(), Optional.empty()));
  }

  /** Returns a session with a simulated hand, which does not run yet. */
  public static TouchSession session(ToolScene scene) {
    return new TouchSession(
        scene, new SimulatedDevice(1, scene.handTarget(), 1_000_000), SessionSettings.standard());
  }
}
