(run with: --optional-stop)
O1 (section 11.5: after the motion of its block)
G90 G00 X1. M01
X2.
M30
(finally status stopped)
(finally machine X1)
