package org.palpate.app.command;

import java.util.List;
import java.util.Optional;
import org.palpate.app.options.ToolOptions;
import org.palpate.app.output.Report;
import org.palpate.app.output.ToolReport;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.HandTarget;
import org.palpate.device.HapticDevice;
import org.palpate.host.ContactScene;
import org.palpate.host.SessionSettings;
import org.palpate.host.ToolScene;
import org.palpate.host.TouchSession;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.tool.MadeTool;
import org.palpate.volume.SegmentedVolume;

/** The scene of a live session, which a point or a rigid tool touches. */
final class SessionScene {
  private final ContactScene scene;
  private final Optional<ToolScene> rigid;
  private final Optional<ToolReport> toolReport;

  private SessionScene(
      ContactScene scene, Optional<ToolScene> rigid, Optional<ToolReport> toolReport) {
    this.scene = scene;
    this.rigid = rigid;
    this.toolReport = toolReport;
  }

  /**
   * Returns the scene of a session.
   *
   * @param made the rigid tool; empty for a point
   * @throws VolumeFormatException if the clearance of the tool is too large for the volume
   */
  static SessionScene of(ContactScene scene, ToolOptions options, Optional<MadeTool> made)
      throws VolumeFormatException {
    if (made.isEmpty()) {
      return new SessionScene(scene, Optional.empty(), Optional.empty());
    }
    return new SessionScene(
        scene,
        Optional.of(options.scene(scene, made.get())),
        Optional.of(new ToolReport(made.get(), options.massKg())));
  }

  /** Returns the volume with its contact settings. */
  ContactScene contactScene() {
    return scene;
  }

  /** Returns the volume that is touched. */
  SegmentedVolume volume() {
    return scene.volume();
  }

  /** Returns the region that a simulated hand touches, world mm. */
  HandTarget handTarget() {
    return rigid.map(ToolScene::handTarget).orElseGet(scene::handTarget);
  }

  /** Returns notes about the device for the user, a sentence each. */
  List<String> notes(DeviceSpecification device) {
    return rigid.isPresent() && !device.hasOrientation()
        ? List.of("The device has no orientation, so the tool is held upright.")
        : List.of();
  }

  /** Returns a new session; see {@link TouchSession}. */
  TouchSession newSession(HapticDevice device, SessionSettings settings) {
    return rigid.isPresent()
        ? new TouchSession(rigid.get(), device, settings)
        : new TouchSession(scene, device, settings);
  }

  /** Adds the fields that depend on the tool to a report. */
  void putInto(Report report, TouchReport measured) {
    if (toolReport.isPresent()) {
      report
          .put("max_torque_nmm", measured.maxTorqueNewtonMm())
          .put("solver", ToolReport.SOLVER)
          .put("collision", ToolReport.COLLISION)
          .put("tool", toolReport.get().tool(measured.mostReducedPoints()))
          .put("faults", measured.toolFaults());
    } else {
      report
          .put("solver", scene.settings().solver().toString())
          .put("collision", scene.settings().collision().toString());
    }
  }
}
