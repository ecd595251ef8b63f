(run with: --set #11001=100 --set #11002=120)
O1 (TLC-2: without a Z word)
G90 G43 H1 Z0
#100=#5023 (expect #100=100)
H2
#101=#5023 (expect #101=120)
#102=#5003 (expect #102=0)
M30
