O1 (LEX-12: only square brackets group)
#100={2+3} (expect alarm PS0009)
M30
