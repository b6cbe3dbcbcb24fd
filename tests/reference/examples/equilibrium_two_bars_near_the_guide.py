"""The position between the two of rest."""
from two_bars import *

print(printed("0.17")[1])
