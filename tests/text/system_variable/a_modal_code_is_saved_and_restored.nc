O1 (section 3.2: #3=#4003 and G#3)
#3=#4003
G91 X1. (expect moves: rapid X1)
G#3
X5. (expect moves: rapid X5)
M30
