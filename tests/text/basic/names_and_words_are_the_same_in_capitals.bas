Alpha=1
ALPHA=alpha+1
GoTo Ende
print "bad"
ENDE: Print aLPHA ' (expect alpha=2)
' (finally prints 2)
