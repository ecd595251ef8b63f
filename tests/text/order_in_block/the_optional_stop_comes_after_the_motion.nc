(run with: --optional-stop)
O1 (section 8: M01 is among the last)
M01 G90 G00 X5. (expect moves: rapid X5)
X9.
M30
(finally status stopped)
(finally machine X5)
