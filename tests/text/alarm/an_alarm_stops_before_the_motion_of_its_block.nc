O1 (section 13: earlier blocks are complete)
G90 G00 X1. (expect moves: rapid X1)
X2. G777 (expect alarm PS0010)
X3.
M30
(finally moves: rapid X1)
(finally status alarm)
