O1 (WCS-1: G91 counts from where the tool stands)
#5241=10.
G55 G91 G00 X1. (expect moves: rapid X1)
M30
