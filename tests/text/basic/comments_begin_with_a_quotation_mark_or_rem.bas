' a line of its own $ "
REM another one $ "
rem
x=1 ' behind a statement
y=2 rem behind a statement $
; ; z=3;;
print x;y;z
' (finally prints 1 2 3)
