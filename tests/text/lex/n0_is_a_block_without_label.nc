O1 (LEX-7: N0 labels nothing, the rest of the block is executed)
N0 #100=1 (expect #100=1)
M30
