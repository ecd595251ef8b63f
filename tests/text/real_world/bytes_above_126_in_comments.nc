O1 (no byte of a comment is wrong)
(·Ά¶―»ϊ Οξ 1)
(Δεςΰλό)
(ιƒ¨ε“ Γ¤Γ¶)
#100=1 (ÿώ€ 7) (expect #100=1)
M30
