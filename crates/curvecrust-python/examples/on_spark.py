"""Curves through more points than one machine holds, on Spark."""

from pyspark.sql import SparkSession


class Spark:
    """An engine for `curvecrust.tiles.reconstruct`."""

    def __init__(self, session: SparkSession):
        self.session = session

    def map(self, step, items):
        context = self.session.sparkContext
        return context.parallelize(list(items), max(1, len(items))).map(step).collect()
