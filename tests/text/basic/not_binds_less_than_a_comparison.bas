print not 1=2; not not 5; not 0; not 3>2; not 1 and 0
' (finally prints 1 1 1 0 0)
