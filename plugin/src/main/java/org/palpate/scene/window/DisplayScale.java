package org.palpate.scene.window;

import java.awt.Component;
import java.awt.GraphicsConfiguration;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * The scale that the user's desktop asks for: pixels of a window for one pixel of text.
 *
 * <p>AWT scales the component of a program that embeds a view. NEWT scales a window of Palpate's
 * own by {@code GDK_SCALE} or {@code QT_SCALE_FACTOR}. Without these, Palpate itself takes AWT's
 * property {@code sun.java2d.uiScale} or variable {@code J2D_UISCALE}.
 */
final class DisplayScale {
  private static final double MAX_SCALE = 8;

  /** The variables by which NEWT scales windows on X11. */
  private static final List<String> BY_NEWT =
      List.of("QT_SCREEN_SCALE_FACTORS", "QT_SCALE_FACTOR", "GDK_SCALE", "SOFT_SCALE");

  private static final double DOTS_PER_INCH_OF_SCALE_1 = 96;

  private DisplayScale() {}

  /** Returns the scale of a component; 1 if it is not shown. */
  static double of(Component component) {
    GraphicsConfiguration shown = component.getGraphicsConfiguration();
    return shown == null ? 1 : limited(shown.getDefaultTransform().getScaleX());
  }

  /** Returns the scale that NEWT leaves to Palpate for a window of its own. */
  static double ofDesktop() {
    return of(System::getProperty, System::getenv);
  }

  /** Returns the scale of the first setting; 1 if there is none or NEWT scales the window. */
  static double of(UnaryOperator<String> property, UnaryOperator<String> variable) {
    if (BY_NEWT.stream().anyMatch(name -> variable.apply(name) != null)) {
      return 1;
    }
    double asked = parse(property.apply("sun.java2d.uiScale"));
    return limited(asked > 0 ? asked : parse(variable.apply("J2D_UISCALE")));
  }

  /** Parses a scale as AWT does: {@code 1.5}, {@code 150%} or {@code 144dpi}; 0 if it is none. */
  private static double parse(String setting) {
    if (setting == null) {
      return 0;
    }
    String text = setting.strip();
    double divisor = text.endsWith("%") ? 100 : text.endsWith("dpi") ? DOTS_PER_INCH_OF_SCALE_1 : 1;
    try {
      return Double.parseDouble(text.replaceFirst("(%|dpi|x)$", "")) / divisor;
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  private static double limited(double scale) {
    return scale >= 1 ? Math.min(MAX_SCALE, scale) : 1;
  }
}
