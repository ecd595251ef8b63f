(run with: --param unit=inch)
O1 (the power-on unit acts from the first block on)
X10. (expect moves: rapid X254)
M30
