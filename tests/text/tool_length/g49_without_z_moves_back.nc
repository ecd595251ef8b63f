(run with: --set #11001=100)
O1 (TLC-2: by the length)
G90 G43 H1 Z0
G49
#100=#5023 (expect #100=0)
M30
