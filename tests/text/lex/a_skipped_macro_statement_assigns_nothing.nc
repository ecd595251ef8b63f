(run with: --block-skip 2)
O1 (LEX-21: the head slash skips, a later slash still divides)
#100=1
/2 #100=6/3 (expect #100=1)
#101=6/2 (expect #101=3)
M30
