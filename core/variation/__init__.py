"""A wall evaluated, and whatever moves one of its inputs."""
