O1 (section 11.5: M00 is recorded, a batch run goes on)
G90 G00 X1. M00
X2. (expect moves: rapid X2)
M30
(finally records: stop)
