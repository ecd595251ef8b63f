(run with: --machine lathe2)
O1 (Codes of builders)
G100X50. (expect assumed: G100 is a code of the builder) (expect moves: none)
G101P3 (expect assumed: G101 is a code of the builder)
G102
G103
M30
