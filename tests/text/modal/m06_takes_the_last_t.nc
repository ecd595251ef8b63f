O1 (G-5: T was called before)
T7
G90 G00 X1.
M06
M30
(finally records: tool 7)
