package org.palpate.app.process;

import picocli.CommandLine.IVersionProvider;

/** Provides the version of this build from the jar's manifest. */
public final class VersionProvider implements IVersionProvider {

  /** Returns the semantic version, or "development" if the classes do not come from a jar. */
  public static String version() {
    String version = VersionProvider.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }

  @Override
  public String[] getVersion() {
    return new String[] {"palpate " + version()};
  }
}
