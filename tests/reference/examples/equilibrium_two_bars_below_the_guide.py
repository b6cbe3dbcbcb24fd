"""The position of rest below the guide."""
from two_bars import *

print(printed("-1.1")[1])
