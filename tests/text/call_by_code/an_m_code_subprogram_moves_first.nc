(run with: --param 6071=50)
O1 (CODE-4: axis words are executed before the call)
G90 G00 X5. M50
M30
O9001
#100=#5001 (expect #100=5)
X6.
M99
(finally moves: rapid X5; rapid X6)
