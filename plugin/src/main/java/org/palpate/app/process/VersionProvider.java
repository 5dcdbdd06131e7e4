package org.palpate.app.process;

import picocli.CommandLine.IVersionProvider;

/** The version of this build, from the jar's manifest. */
public final class VersionProvider implements IVersionProvider {

  /** The semantic version, or "development" where classes do not come from a jar. */
  public static String version() {
    String version = VersionProvider.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }

  @Override
  public String[] getVersion() {
    return new String[] {"palpate " + version()};
  }
}
